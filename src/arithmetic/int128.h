//: Name the integers of 128 bits
#pragma once

__extension__ typedef __int128 tf_int128;
__extension__ typedef unsigned __int128 tf_uint128;
