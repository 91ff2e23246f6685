//: Declare the names of methods
#pragma once

#include "arithmetic/arithmetic.h"
#include "base/status.h"
#include "files/query_file.h"
#include "query/contact.h"

#include <stdbool.h>

/// A way to answer a query.
typedef struct tf_method tf_method;

/// The names that tf_method_named accepts, for help and messages.
#define TF_METHOD_NAMES "spacetime, cubic or advancement"

/// The method of that name; NULL if there is none.
const tf_method *tf_method_named(const char *name);

/// The name of a method.
const char *tf_method_name(const tf_method *method);

//: Declare what methods take
/// What a method takes besides the query.
typedef enum tf_method_option {
    TF_TAKES_ARITHMETIC = 1,
    TF_TAKES_TOLERANCE = 2,
    TF_TAKES_THRESHOLD = 4
} tf_method_option;

/// Which of the options a method takes.
tf_method_option tf_method_takes(const tf_method *method);

/// The options of all methods; each reads its own.
typedef struct tf_method_options {
    const tf_arithmetic *arithmetic;
    double tolerance, threshold;
} tf_method_options;

/// Answers a query of a file.
tf_status tf_method_answer(const tf_method *method,
                           const tf_method_options *options,
                           const tf_query_kind *kind,
                           const tf_query_rows *query, tf_contact *contact);
