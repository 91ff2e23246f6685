//: Mark what the library exports
#pragma once

/// A function or constant that the library offers its users; everything else
/// is hidden inside it.  A header that includes this one is public: it becomes
/// part of tanglefree.h.
#ifdef __GNUC__
#define TF_API __attribute__((visibility("default")))
#else
#define TF_API
#endif
