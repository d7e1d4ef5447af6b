#include "simple.hpp"
LINKED_COMPONENT(One)
