import { fromBase64 } from '@botgarten/browsers'
import { pixelsAddress } from '#content/cards.ts'
import type { Project } from '@botgarten/programs'
import type { Picture, World } from '@botgarten/simulation'

/** Pixels that were asked for before anybody needs them, by their address. */
const early = new Map<string, Promise<Response>>()

/** Asks for the pixels of a floor, so that they travel beside what says that they are needed. */
export function askForPixels(floor: World['floor']): void {
  const address = pixelsAddress({ floor })
  if (address === null) return
  const answer = fetch(address)
  // Who needs them hears of it.
  answer.catch(() => undefined)
  early.set(address, answer)
}

function pixelsAt(address: string): Promise<Response> {
  const answer = early.get(address) ?? fetch(address)
  early.delete(address)
  return answer
}

/**
 * The picture that a world lies on, unpacked: a child's own from the project, ours from the pixels that the build has made
 * of it. Null where there is no such picture.
 * @throws FloorError when an own picture cannot be used
 */
export async function pictureIn(
  world: Pick<World, 'floor'>,
  own: Project['assets'][string] | undefined,
): Promise<Picture | null> {
  if (own) {
    const { readPng } = await import('@botgarten/simulation/png')
    return readPng(fromBase64(own.base64))
  }
  const address = pixelsAddress(world)
  return address === null ? null : unpack(await pixelsAt(address))
}

/** Width and height, four bytes each, then the pixels; all of it deflated, which the browser undoes itself. */
async function unpack({ body }: Response): Promise<Picture> {
  const all = await new Response(body!.pipeThrough(new DecompressionStream('deflate'))).arrayBuffer()
  const size = new DataView(all)
  return { width: size.getUint32(0), height: size.getUint32(4), data: new Uint8Array(all, 8) }
}
