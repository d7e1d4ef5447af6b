#pragma once
namespace bad {
struct Sized { explicit Sized(int n) : size(n) {} int size; };
struct Deleted { Deleted() = delete; int x; };
struct Moved { Moved() = default; Moved(Moved&&) = default; int x; };
class Single { public: Single() = default; int x; private: Single(const Single&); };
struct Through { Sized sized; };
}
