#include "simple.hpp"
LINKED_COMPONENT(Archived)
