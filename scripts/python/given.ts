import { readdirSync, readFileSync } from 'node:fs'
import { inHouse } from '../prepare/house.mjs'

const folder = inHouse('packages/programs/testing/open-roberta')

/** Files of Open Roberta that the project was given: `programs/upstream__ev3__action`. */
export const givenNames = (): readonly string[] =>
  ['programs', 'thesis'].flatMap((part) =>
    readdirSync(`${folder}/${part}`)
      .filter((file) => file.endsWith('.xml'))
      .map((file) => file.replace(/\.xml$/, '')),
  )

export function readGiven(name: string): string {
  const part = readdirSync(`${folder}/thesis`).includes(`${name}.xml`) ? 'thesis' : 'programs'
  return readFileSync(`${folder}/${part}/${name}.xml`, 'utf8')
}
