//: Declare the names of methods
#pragma once

#include "arithmetic/arithmetic.h"
#include "base/status.h"
#include "files/choice.h"
#include "files/query_file.h"
#include "query/contact.h"

/// A way to answer a query.
typedef struct tf_method tf_method;

/// The methods by their names.
extern const tf_choice tf_methods[];

/// The name of the one option that a method takes.
const char *tf_method_option(const tf_method *method);

//: Declare how to answer a query
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
