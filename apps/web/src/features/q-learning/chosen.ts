/** What a hand has tapped: a station or a road of the map, or start and goal beside it. */
export type Chosen =
  | { readonly kind: 'station'; readonly station: number }
  | { readonly kind: 'road'; readonly a: number; readonly b: number }
  | { readonly kind: 'ends' }
