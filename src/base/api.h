//: Mark what the library exports
#pragma once

/// A function or constant that the library offers its users; everything else
/// is hidden inside it.  A header that includes this one is public: it becomes
/// part of tanglefree.h.
///
/// On Windows, define TF_BUILD_DLL to compile the library as a DLL, and TF_DLL
/// to compile a program that uses the DLL; define neither for a static library.
/// With TF_DLL, C does not accept the addresses of the library's constants as
/// initial values of static variables.  Anywhere, define TF_API to mark
/// everything in a way of your own.
#ifndef TF_API
#if defined _WIN32 && defined TF_BUILD_DLL
#define TF_API __declspec(dllexport)
#elif defined _WIN32 && defined TF_DLL
#define TF_API __declspec(dllimport)
#elif defined __GNUC__ && !defined _WIN32
#define TF_API __attribute__((visibility("default")))
#else
#define TF_API
#endif
#endif
