"""What the image of a GPU says of its kernels (check_gpu_image), and the page of a visit to a GPU (gpu_report)."""
