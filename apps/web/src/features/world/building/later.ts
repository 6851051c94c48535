import { Builder } from './builder.svelte.ts'
import type { BuildMode } from '../build-mode.svelte.ts'
/** The tools for building, with the floor as it is. */
export async function openWorkshop(mode: BuildMode): Promise<Builder> {
  const builder = new Builder(mode)
  await builder.open()
  return builder
}
