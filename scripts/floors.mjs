// Draws the floor that sensors read from each content/worlds/*/floor.svg: its groups `floor` and `scenery`, 2 pixels a cm.
// Run after a drawing has changed: node scripts/floors.mjs
import { globSync, readFileSync, writeFileSync } from 'node:fs'
import { chromium } from '@playwright/test'

const PIXELS_PER_CM = 2

const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium'
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-gpu'] })
for (const file of globSync('content/worlds/*/floor.svg')) {
  const svg = readFileSync(file, 'utf8')
  const [, width, height] = /viewBox="0 0 (\d+) (\d+)"/.exec(svg).map(Number)
  const page = await browser.newPage({
    viewport: { width: width * PIXELS_PER_CM, height: height * PIXELS_PER_CM },
  })
  await page.setContent(
    `<style>body{margin:0}svg{display:block;width:100vw;height:100vh}#obstacles,#over{display:none}</style>${svg}`,
  )
  const picture = await page.screenshot()
  writeFileSync(file.replace('.svg', '.png'), picture)
  console.log(`${file}: ${picture.length} bytes`)
}
await browser.close()
