import type { Feature } from '#parts/feature.ts'

type Door = { readonly [name: string]: unknown }

const isFeature = (one: unknown): one is Feature =>
  typeof one === 'object' && one !== null && 'id' in one && 'words' in one

const doors = import.meta.glob<Door>('../features/*/feature.ts', { eager: true })

/** Every feature by its folder: what its door says of it. */
export const features: ReadonlyMap<string, Feature> = new Map(
  Object.entries(doors).flatMap(([path, door]) =>
    Object.values(door)
      .filter(isFeature)
      .map((feature) => [path.split('/').at(-2)!, feature] as const),
  ),
)
