#pragma once
struct AlsoBad { union { int a; float b; }; };
struct Typo { doubel x; };
struct UsesTypo { Typo typo; int* q; };
