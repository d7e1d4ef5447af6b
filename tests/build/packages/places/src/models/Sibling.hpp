#pragma once
namespace places { struct Sibling { int b; }; }
