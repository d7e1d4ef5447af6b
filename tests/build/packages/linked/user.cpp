#include "simple.hpp"
LINKED_COMPONENT(User)
