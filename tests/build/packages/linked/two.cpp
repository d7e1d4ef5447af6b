#include "simple.hpp"
LINKED_COMPONENT(Two)
