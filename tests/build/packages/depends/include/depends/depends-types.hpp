#pragma once
#include <places/folder/sub.hpp>
#include <places/root-types.hpp>
namespace depends { struct Both { places::Root root; places::Sub sub; }; }
