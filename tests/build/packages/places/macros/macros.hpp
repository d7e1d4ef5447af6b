#define FROM_MACROS 3
