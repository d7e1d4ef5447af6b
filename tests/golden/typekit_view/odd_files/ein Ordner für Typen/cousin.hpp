#pragma once
namespace odd_files {
struct Cousin { int y; };
}
