#pragma once
namespace places { struct Root { [[oro::unit("m"), oro::range(0, 5)]] int a; }; }
