import { pictured, type Explained } from './explained-lab.ts'

/** Room around the screen for numbers, in px of the screen. */
const margin = 84
const radius = 30
/** Numbers stand so far apart. */
const apart = 2 * radius + 8

/** A picture of the screen with a number at each place, and an arrow from it. */
export function explainedPicture(screen: Uint8Array, places: readonly Explained[]): string {
  const { width, height } = pictured
  const size = `width="${width}" height="${height}"`
  const marks = badgesOf(places).map(({ x, y, badge }, at) => {
    const line = `<path d="M${badge.x} ${badge.y}L${x} ${y}"/><circle class="end" cx="${x}" cy="${y}" r="9"/>`
    const number = `<text x="${badge.x}" y="${badge.y + 13}">${at + 1}</text>`
    return `<g>${line}<circle cx="${badge.x}" cy="${badge.y}" r="${radius}"/>${number}</g>`
  })
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${-margin} ${-margin} ${width + 2 * margin} ${height + 2 * margin}">
<style>${style}</style>
<image href="data:image/jpeg;base64,${Buffer.from(screen).toString('base64')}" ${size}/>
<rect ${size} rx="14" fill="none" stroke="#3d2b20" stroke-width="6"/>
${marks.join('\n')}
</svg>
`
}

const style = [
  'path{stroke:#3d2b20;stroke-width:5}circle{fill:#3d2b20}.end{fill:#ffc83d;stroke:#3d2b20;stroke-width:4}',
  'text{fill:#fff;font:700 36px Nunito,sans-serif;text-anchor:middle}',
].join('')

/** Where the numbers of each side stand. */
const fixed = {
  top: radius + 4 - margin,
  left: radius + 4 - margin,
  bottom: pictured.height + margin - radius - 4,
  right: pictured.width + margin - radius - 4,
}

/** Each place with where its number stands: beside the screen, as near as the others let it. */
const badgesOf = (places: readonly Explained[]) =>
  places.map((place) => {
    const { side } = place
    const beside = side === 'left' || side === 'right'
    const along = ({ x, y }: Explained) => (beside ? y : x)
    const sorted = places
      .filter((one) => one.side === side)
      .map(along)
      .toSorted((a, b) => a - b)
    const at = pushed(sorted, sorted.indexOf(along(place)))
    return { ...place, badge: beside ? { x: fixed[side], y: at } : { x: at, y: fixed[side] } }
  })

/** Where the number of one of these stands, from the left on: not nearer to the one before than they may be. */
function pushed(sorted: readonly number[], index: number): number {
  const at = sorted[index]!
  return index === 0 ? at : Math.max(at, pushed(sorted, index - 1) + apart)
}

/** The places in a picture that was made so. */
export const placesIn = (svg: string): readonly (readonly [number, number])[] =>
  [...svg.matchAll(/class="end" cx="([\d.-]+)" cy="([\d.-]+)"/g)].map(([, x, y]) => [Number(x), Number(y)])
