#pragma once
namespace bad {
struct Wide {
    long double precise;
    __int128 huge;
    wchar_t letter;
    char32_t code;
};
}
