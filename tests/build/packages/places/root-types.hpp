#pragma once
namespace places { struct Root { int a; }; }
