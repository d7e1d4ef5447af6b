#pragma once
#include <string>
using std::string;
