import { readFile } from 'node:fs/promises'
import { basename, dirname, join } from 'node:path'
import { deflateSync } from 'node:zlib'
import type { Plugin } from 'vite'
import { readPng } from '../../packages/simulation/floor/png.ts'

const worlds = join(import.meta.dirname, '../../content/worlds')
/** Where they lie without a build: the page's policy lets nothing be fetched from an address that is its own content. */
const whileDeveloping = '/pixels'

/**
 * `content/worlds/<world>/floor.png?pixels`: the address of the picture's pixels as the robot's sensors read them (width,
 * height, then R, G, B), deflated. So a page needs no reader of PNG for the worlds that we bring.
 */
export const pixels: Plugin = {
  name: 'pixels',
  enforce: 'pre',
  configureServer({ middlewares }) {
    middlewares.use(whileDeveloping, (request, response) => {
      const world = basename(request.url ?? '')
      readFile(join(worlds, world, 'floor.png')).then(
        (file) => response.end(pack(file)),
        () => response.writeHead(404).end(),
      )
    })
  },
  load: {
    filter: { id: /\.png\?pixels$/ },
    async handler(id) {
      const file = id.split('?')[0]!
      const world = basename(dirname(file))
      if (this.environment.mode !== 'build') return `export default '${whileDeveloping}/${world}'`
      const source = pack(await readFile(file))
      const name = this.emitFile({ type: 'asset', name: `${world}.pixels`, source })
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
