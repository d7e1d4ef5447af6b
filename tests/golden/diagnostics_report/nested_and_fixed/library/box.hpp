#pragma once
namespace library {
class Locked { int secret; };
template <class T> struct Box { T content; };
}
