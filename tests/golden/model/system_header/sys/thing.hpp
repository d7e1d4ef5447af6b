#pragma once
// Case 86 of the type matrix: a header of the system that is asked for.
namespace thing { struct Device { int number; char name[8]; }; }
