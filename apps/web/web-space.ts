import { rmSync } from 'node:fs'
import type { Adapter } from '@sveltejs/kit'

/** Writes the product as files that any web space serves, in whatever folder they lie. */
export const webSpace = (folder: string): Adapter => ({
  name: 'web-space',
  adapt(builder) {
    rmSync(folder, { recursive: true, force: true })
    builder.writeClient(folder)
    builder.writePrerendered(folder)
  },
})
