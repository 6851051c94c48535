import { readFile } from 'node:fs/promises'
import { deflateSync } from 'node:zlib'
import type { Plugin } from 'vite'
import { readPng } from '../../packages/simulation/floor/png.ts'

/**
 * `content/worlds/<world>/floor.png?pixels`: the address of the picture's pixels as the robot's sensors read them (width,
 * height, then R, G, B), deflated. So a page needs no reader of PNG for the worlds that we bring.
 */
export const pixels: Plugin = {
  name: 'pixels',
  enforce: 'pre',
  load: {
    filter: { id: /\.png\?pixels$/ },
    async handler(id) {
      const file = id.split('?')[0]!
      const packed = pack(await readFile(file))
      if (this.environment.mode !== 'build')
        return `export default 'data:application/octet-stream;base64,${packed.toString('base64')}'`
      const [, world] = /([\w-]+)[\\/]floor\.png$/.exec(file)!
      const name = this.emitFile({ type: 'asset', name: `${world}.pixels`, source: packed })
      return `export default import.meta.ROLLUP_FILE_URL_${name}`
    },
  },
}

function pack(png: Buffer): Buffer {
  const { width, height, data } = readPng(png)
  const size = Buffer.alloc(8)
  size.writeUInt32BE(width, 0)
  size.writeUInt32BE(height, 4)
  return deflateSync(Buffer.concat([size, data]), { level: 9 })
}
