#pragma once
#include <string>
namespace needy {
struct Label {
    string text;
};
}
