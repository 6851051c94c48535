// Draws the icons of the web app manifest from apps/web/static/icon.svg, Bo's drawing. Run after that has changed: npm run icons
import { readFileSync, writeFileSync } from 'node:fs'
import { launchBrowser } from '../e2e/browser.ts'
import { inHouse } from './prepare/house.mjs'

const inStatic = (name: string) => inHouse('apps', 'web', 'static', name)
const drawing = readFileSync(inStatic('icon.svg'), 'utf8')

/** A system may cut a `maskable` icon to a circle of 80 %: it has a ground, and Bo is smaller. */
const icons = [
  { name: 'icon-192.png', size: 192, share: 1, ground: 'transparent' },
  { name: 'icon-512.png', size: 512, share: 1, ground: 'transparent' },
  { name: 'icon-mask-512.png', size: 512, share: 0.62, ground: '#D9E3A9' },
  { name: 'icon-180.png', size: 180, share: 0.74, ground: '#D9E3A9' },
]

const browser = await launchBrowser()
for (const { name, size, share, ground } of icons) {
  const page = await browser.newPage({ viewport: { width: size, height: size } })
  const look = `body{margin:0;display:grid;place-items:center;height:100vh;background:${ground}}svg{width:${share * 100}%;height:${share * 100}%}`
  await page.setContent(`<style>${look}</style>${drawing}`)
  const picture = await page.screenshot({ omitBackground: true })
  writeFileSync(inStatic(name), picture)
  console.log(`${name}: ${picture.length} bytes`)
  await page.close()
}
await browser.close()
