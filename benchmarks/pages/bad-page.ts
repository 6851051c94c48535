import type { Finding } from './findings.ts'

const line = 'position: absolute; left: 20px; font: 16px sans-serif;'

/** A page with one mistake of each sort: whoever looks at pages has to find all of them. */
export const badPage = `<!doctype html><html lang="de"><body style="margin: 0; background: #fff">
<article class="paper"><section class="leaf" style="position: relative; width: 600px; height: 800px; overflow: hidden">
  <p style="${line} top: 20px">Zeile eins</p><p style="${line} top: 26px">Zeile zwei</p>
  <p style="${line} top: 80px">Verdeckt</p>
  <div style="${line} top: 70px; width: 90px; height: 60px; background: #fff"></div>
  <p style="${line} top: 150px; width: 60px; overflow: hidden; white-space: nowrap">Abgeschnittenes Wort</p>
  <svg viewBox="0 0 100 20" style="${line} top: 200px; width: 100px"><text x="60" y="15" font-size="16">Hinaus aus dem Bild</text></svg>
  <figure aria-label="Leer" style="${line} top: 260px; width: 90px; height: 60px"></figure>
  <p style="${line} top: 340px">Turn the knob</p>
  <p style="${line} top: 400px; color: #999">Blass</p>
  <p style="${line} top: 460px; font-size: 8px">Winzig</p>
</section></article></body></html>`

/** What has to be found on it. */
const mistakes: readonly Finding[] = [
  { kind: 'overlap', what: 'Zeile eins' },
  { kind: 'overlap', what: 'Verdeckt' },
  { kind: 'cut', what: 'Abgeschnittenes' },
  { kind: 'cut', what: 'Hinaus' },
  { kind: 'empty', what: 'Leer' },
  { kind: 'language', what: 'the' },
  { kind: 'pale', what: 'Blass' },
  { kind: 'small', what: 'Winzig' },
]

/** Mistakes that were overlooked. */
export const overlooked = (findings: readonly Finding[]): readonly Finding[] =>
  mistakes.filter(
    ({ kind, what }) => !findings.some((found) => found.kind === kind && found.what.includes(what)),
  )
