#pragma once
// Cases 93 to 95 of the type matrix: a folder with blanks and letters of another language; a file beside this one.
#include "sub/sibling.hpp"
namespace odd_files {
struct Uses { Sibling sibling; };
}
