import { chromium } from 'playwright'
const [,, card, out, w='1366', h='768', lang='en', steps=''] = process.argv
const b = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox','--disable-gpu','--disable-quic','--no-first-run','--disable-background-networking','--disable-component-update','--disable-sync'] })
const c = await b.newContext({ viewport: { width: +w, height: +h }, locale: lang })
const p = await c.newPage()
p.on('console', m => { if (['error','warning'].includes(m.type())) console.log(m.type(), m.text().slice(0,400)) })
p.on('pageerror', e => console.log('PAGEERROR', e.message.slice(0,600), (e.stack||'').split('\n').slice(1,5).join('|')))
await p.goto((process.env.BASE ?? 'http://localhost:5187') + '/lab/' + card)
await p.waitForSelector('.q svg', { timeout: 60000 }).catch(e => console.log('no q'))
await p.waitForSelector('.blocklyBlockCanvas .blocklyDraggable', { timeout: 60000 }).catch(e => console.log('no blocks'))
await p.waitForTimeout(800)
let n = 0
for (const s of steps.split(';').filter(Boolean)) {
  const [k, ...v] = s.split('='); const a = v.join('=')
  if (k === 'click') await p.getByRole('button', { name: a, exact: true }).first().click()
  if (k === 'css') await p.locator(a).first().click()
  if (k === 'wait') await p.waitForTimeout(+a)
  if (k === 'eval') console.log(JSON.stringify(await p.evaluate(a)))
  if (k === 'level') await p.locator('.level select').selectOption(a)
  if (k === 'shot') await p.screenshot({ path: `/tmp/hc-scratch/${out}-${a}.png` })
}
await p.screenshot({ path: `/tmp/hc-scratch/${out}.png` })
await b.close()
