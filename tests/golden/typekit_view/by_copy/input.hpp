#pragma once
#include <chrono>
#include <string>
// Cases 36, 39 to 41, 46, 47, 64 and 71 of the type matrix: fields without an address of their own.
namespace by_copy {
struct Bits {
    unsigned low : 3;
    int signedBits : 5;
    unsigned : 0;
    unsigned high : 12;
    bool flag : 1;
};
struct __attribute__((packed)) Packed { char head; double value; float list[3]; char tail; };
struct Tag {};
struct Shares { [[no_unique_address]] Tag tag; int number; };
struct Cached {
    int value = 0;
    int* cache = nullptr;  ///< made anew where it is needed @skip
    [[oro::skip]] void (*changed)() = nullptr;
};
/// For the implementation only. @skip
struct Hidden { int* p; };
struct alignas(32) Wide { double values[4]; };
class Box {
public:
    double width() const { return width_; }
    void setWidth(double width) { width_ = width; }
    const std::string& getName() const { return m_name; }
    void setName(const std::string& name) { m_name = name; }
    int depth() const { return depth_; }
    int& depth() { return depth_; }
    std::chrono::milliseconds delay() const { return delay_; }
    void set_delay(std::chrono::milliseconds delay) { delay_ = delay; }
    int count = 0;

private:
    double width_ = 0;
    std::string m_name;
    int depth_ = 0;
    std::chrono::milliseconds delay_{0};
};
}
