// Makes a database of results without rows: make_empty_database FILE
#include "elsie/results/database_file.h"

int main(int, char** words) {
  auto database = elsie::results::make_database(words[1]);
  elsie::results::make_schema(database);
}
