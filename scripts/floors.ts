// Draws the floor that sensors read from each content/worlds/*/floor.svg: its groups `floor` and `scenery`, 2 pixels a cm.
// Run after a drawing has changed: `npm run floors`, or `npm run floors -- maze` for one world.
import { content } from '@botgarten/content/files'
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { launchBrowser } from '../e2e/browser.ts'

const PIXELS_PER_CM = 2
const look = 'body{margin:0}svg{display:block;width:100vw;height:100vh}#obstacles,#over{display:none}'

const browser = await launchBrowser()
const wanted = process.argv.slice(2)
const worlds = wanted.length > 0 ? wanted : content.worlds
const drawings = worlds.map((id) => content.path('worlds', id, 'floor.svg'))
for (const file of drawings.filter((drawing) => existsSync(drawing))) {
  const svg = readFileSync(file, 'utf8')
  const [, width, height] = /viewBox="0 0 (\d+) (\d+)"/.exec(svg)?.map(Number) ?? []
  if (width === undefined || height === undefined) throw new Error(`${file} does not say how large it is.`)
  const viewport = { width: width * PIXELS_PER_CM, height: height * PIXELS_PER_CM }
  const page = await browser.newPage({ viewport })
  await page.setContent(`<style>${look}</style>${svg}`)
  const picture = await page.screenshot()
  writeFileSync(file.replace('.svg', '.png'), picture)
  console.log(`${file}: ${picture.length} bytes`)
}
await browser.close()
