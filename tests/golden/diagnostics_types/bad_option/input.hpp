#pragma once
struct Fine { int x; };
