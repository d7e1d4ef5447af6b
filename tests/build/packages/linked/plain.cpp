#include "simple.hpp"
LINKED_COMPONENT(Plain)
