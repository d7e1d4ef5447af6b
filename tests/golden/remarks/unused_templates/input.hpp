#pragma once
// Cases 51 and 52 of the type matrix.
namespace remarks {
template <class T> struct Box { T value; };
template <class T> struct Unused { T* pointer; };
template <> struct Box<char> { int code; };
struct Holder { Box<int> box; };
}
