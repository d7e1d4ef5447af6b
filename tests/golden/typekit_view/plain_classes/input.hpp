#pragma once
#include <string>
#include <vector>
// Cases 13, 35, 48, 56, 65, 67, 75 to 78 of the type matrix.
namespace plain_classes {
constexpr int twice(int n) { return 2 * n; }
inline double firstLevel() { return 1.5; }
#define FIELD(type, name) type name
#define RECORD(name) struct name { int id = 0; FIELD(double, value) = 0; }
RECORD(Made);
enum class Late : short;
struct Early { Late late; };
enum class Late : short { Now = 1, Then };
struct Node {
    std::string name;
    std::vector<Node> children;
};
/// Wärme.
class Heater {
public:
    Heater() : power(4) {}
    explicit Heater(int watts) : power(watts) {}
    bool operator==(const Heater& other) const { return power == other.power; }
    static constexpr int kStages = 3;
    static int count;
    int power;
    double stages[kStages] = {};
    short doubled[twice(2)] = {};
    double level = firstLevel();  ///< Füllstand @unit m @range 0..2.5
};
class Guarded {
public:
    int open = 0;

private:
    friend struct Key;
    int hidden = 0;  ///< @skip
};
struct Key {
    static int& of(Guarded& guarded) { return guarded.hidden; }
    int number = 0;
};
inline int local() {
    struct Local { int* p; };
    return sizeof(Local);
}
}
