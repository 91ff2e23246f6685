//: Mark what the library exports
#pragma once

// A function or constant that the library offers its users; everything else
// is hidden inside it.  A header that includes this one is public: it becomes
// part of tanglefree.h.
//
// On Windows, define TF_BUILD_DLL to compile the library as a DLL, and TF_DLL
// to compile a program that uses the DLL; define neither for a static library.
// With TF_DLL, C does not accept the addresses of the library's constants as
// initial values of static variables.  Anywhere, define TF_API to mark
// everything in a way of your own.
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

//: Say what holds for all functions
/// @defgroup conventions Conventions
/// What holds for all functions.
///
/// Arguments come in one order: the object; counts, each before the lists that
/// it counts; what else is given; options; results; and last the error.  A
/// callback gets its context first.  No pointer may be null unless the function
/// says so; a null pointer is the one mistake that ends the program.  Whatever
/// data can cause, a negative count, a bad index or a NaN, is a status.
///
/// In options zero is the usual choice, and a negative number switches off what
/// can be switched off.  Options begin with their size, which may be left zero
/// as well: then they are those of version 1.0.
///
/// Structs do not change their layout within a major version, with two
/// exceptions, which may get members at their end: options, as they have a size;
/// and what the library lends, as reports, statistics and stages.  So a program
/// never copies those as arrays.  Enumerations may get values.
///
/// What is lent belongs to the library.  It is valid until the next call for the
/// same object, unless the function says more.
///
/// A function that does not return TF_OK has changed nothing, and its results
/// are not set, but its error is.
