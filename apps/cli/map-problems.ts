import type { MapProblem } from '@botgarten/materials/maps'

type Facts = MapProblem['facts']

const sentences: { readonly [kind in MapProblem['kind']]: (facts: Facts) => string } = {
  notXml: ({ line }) => `it is no whole XML document (line ${line})`,
  tooLarge: ({ most }) => `it has more than ${most} characters`,
  noDrawing: () => 'it is no SVG drawing',
  unsafe: ({ name }) => `"${name}" is more than a drawing and is not taken`,
  idTwice: ({ name }) => `the name ${name} is there twice`,
  noStations: () => 'it has no station: a station is called node-0, node-1 and so on',
  tooManyStations: ({ count, most }) => `it has ${count} stations; ${most} can be there`,
  stationMissing: ({ name, count }) =>
    `${name} is missing: ${count} stations are numbered from 0 without a gap`,
  stationPlace: ({ name }) => `${name} has no place: transform="translate(x y)"`,
  pathToNowhere: ({ name, station }) => `${name} leads to a station ${station} that is not there`,
  pathToItself: ({ name }) => `${name} leads from a station to itself`,
  pathShape: ({ name }) => `${name} is no road of straight lines (L) and arcs of a circle (A)`,
  pathEnd: ({ name, station }) => `${name} does not end at station ${station}`,
  number: ({ name, value }) => `${name} is "${value}", not a number`,
  grid: ({ why }) => `its grid is none: ${why}`,
}

export const sentenceFor = ({ kind, facts }: MapProblem): string => sentences[kind](facts)
