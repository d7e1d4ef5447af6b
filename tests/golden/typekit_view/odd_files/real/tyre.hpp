#pragma once
namespace odd_files {
struct Tyre { double radius; };
}
