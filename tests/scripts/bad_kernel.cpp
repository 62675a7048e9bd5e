// A kernel as none of ours may be, for gpu_image_test.py: the statement between `teams` and `parallel` makes one lane
// run while the others wait for work (generic mode), lanes share `values` and `sums`, which without -fopenmp-cuda-mode
// may come from the heap, parallel regions inside of parallel regions make OpenMP call functions through pointers, and
// all `sums` want registers at once.
namespace {

constexpr int width = 64;

void sum_rows(int num_rows, int num_columns, const double* rows, double* results) {
#pragma omp target teams distribute is_device_ptr(rows, results)
  for (int row = 0; row < num_rows; ++row) {
    double values[width], total = 0;
    asm volatile("" ::: "memory");
#pragma omp parallel for
    for (int i = 0; i < width; ++i) values[i] = rows[row * width + i];
#pragma omp parallel for reduction(+ : total)
    for (int column = 0; column < num_columns; ++column) {
      double sums[width], products[width];
      for (int i = 0; i < width; ++i) products[i] = sums[i] = values[i] * rows[column];
      for (int j = 0; j < num_columns; ++j)
        for (int i = 0; i < width; ++i) products[i] = products[i] * values[j] + products[width - 1 - i];
#pragma omp parallel for
      for (int i = 0; i < width; ++i) results[column * width + i] = sums[i];
      for (int i = 0; i < width; ++i) total += products[i] * i;
    }
    results[row] = total;
  }
}

}  // namespace

int main(int num_arguments, char**) {
  double values[width] = {};
  if (num_arguments > 1) sum_rows(1, 1, values, values);
}
