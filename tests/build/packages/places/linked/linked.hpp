#pragma once
namespace places { struct Linked { int number; }; }
