#pragma once
#include "unguarded.hpp"
#include "unguarded.hpp"
