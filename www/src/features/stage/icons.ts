/** Strokes of the icons for grids and stops, apart from those of the first view. */
export const icons = {
  addStop: 'M8.5 17.5S3.7 12.7 3.7 8.9a4.8 4.8 0 0 1 6.2-4.6M13.2 10.4c-.8 3.6-4.7 7.1-4.7 7.1M14.5 2.5v6M11.5 5.5h6M8.5 8.6h.01',
  addMoving: 'M7 7a4.5 4.5 0 1 0 4.5 4.5M9 9.5l4-4M9.5 5.2h3.8v3.8M16 11.5v5M13.5 14h5',
  hand: 'M7 10V5.2a1.1 1.1 0 0 1 2.2 0V9 4.2a1.1 1.1 0 0 1 2.2 0V9 5.2a1.1 1.1 0 0 1 2.2 0v5.3V8a1.1 1.1 0 0 1 2.2 0v4a5 5 0 0 1-5 5h-.6a5 5 0 0 1-4-2L3.6 11.6a1.2 1.2 0 0 1 1.9-1.4L7 12Z',
  brush: 'M3.5 4h4v4h-4ZM8 4h4v4H8ZM3.5 8.5h4v4h-4ZM10 16.5l.5-2.8L15 9.2l2.3 2.3-4.5 4.5Z',
  lens: 'M8.8 3.5a5.3 5.3 0 1 1 0 10.6 5.3 5.3 0 0 1 0-10.6ZM12.7 12.7l4 4M6.8 8.8h4M8.8 6.8v4',
} as const
