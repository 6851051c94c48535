import { readFile } from 'node:fs/promises'
import { vi } from 'vitest'

/** Requests for files of the content are answered from the disk, until `vi.unstubAllGlobals()`. */
export function assetsFromDisk(): void {
  vi.stubGlobal('fetch', async (address: string) => {
    const path = address.replace(/^\/@fs\/?/, '').replace(/\?.*$/, '')
    return new Response(await readFile(new URL(`file:///${path}`)))
  })
}
