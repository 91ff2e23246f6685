//: Describe an error
#include "base/describe.h"

#include "base/sentence.h"

size_t tf_describe(const tf_error *error, char buffer[], size_t size)
{
    return tf_sentence_write(error, 0, false, buffer, size);
}
