#pragma once
namespace bad {
struct Good { int x; };
struct Bad { int* p; };
struct UsesBad { Bad bad; Good good; };
}
