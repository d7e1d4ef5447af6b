#pragma once
namespace two_headers { struct First { int a; }; }
