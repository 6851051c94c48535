/** What a hand has tapped on the map. */
export type Chosen =
  | { readonly kind: 'station'; readonly station: number }
  | { readonly kind: 'road'; readonly a: number; readonly b: number }
