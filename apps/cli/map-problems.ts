import type { MapProblem } from '@botgarten/materials/maps'

type Facts = MapProblem['facts']

const sentences: { readonly [kind in MapProblem['kind']]: (facts: Facts) => string } = {
  notXml: ({ line }) => `it is no whole XML document (line ${line})`,
  tooLarge: ({ most }) => `it has more than ${most} characters`,
  tooManyElements: ({ most }) => `it has more than ${most} elements`,
  tooManyAttributes: ({ most }) => `one of its elements has more than ${most} attributes`,
  tooDeep: ({ most }) => `its groups stand in each other more than ${most} deep`,
  noDrawing: () => 'it is no SVG drawing',
  unsafe: ({ name }) => `"${name}" is more than a drawing and is not taken`,
  idTwice: ({ name }) => `the name ${name} is there twice`,
  noStations: () => 'it has no station: a station is called node-0, node-1 and so on',
  tooManyStations: ({ count, most }) => `it has ${count} stations; ${most} can be there`,
  stationMissing: ({ name, count }) =>
    `${name} is missing: ${count} stations are numbered from 0 without a gap`,
  stationPlace: ({ name }) =>
    `${name} has no place: draw it as a circle, or move its group by transform="translate(x y)"`,
  pathToNowhere: ({ name, station }) => `${name} leads to a station ${station} that is not there`,
  pathToItself: ({ name }) => `${name} leads from a station to itself`,
  pathShape: ({ name }) => `${name} is no road: it is not a path, a line or a polyline that can be read`,
  pathGap: ({ name }) => `${name} has a gap: a road is one line without a jump`,
  pathPieces: ({ name, most }) => `${name} is drawn with more than ${most} pieces`,
  pathLong: ({ name, most }) => `${name} has more than ${most} characters of path data`,
  pathsLong: ({ name, most }) =>
    `its roads have more than ${most} characters of path data; from ${name} on they are not read`,
  pathEnd: ({ name, station }) => `${name} does not end at station ${station}`,
  transform: ({ name, value }) => `${name} is moved by "${shorten(value!)}", which is no transform of SVG`,
  tooFar: ({ name }) => `${name} leads farther than a million units`,
  strangeId: ({ name }) =>
    `"${shorten(name!)}" is neither a station (node-0) nor a road (path-3-5) and is not read`,
  number: ({ name, value }) => `${name} is "${value}", not a number`,
  grid: ({ why }) => `its grid is none: ${why}`,
}

export const sentenceFor = ({ kind, facts }: MapProblem): string => sentences[kind](facts)

const shorten = (text: string | number) => (String(text).length > 40 ? `${String(text).slice(0, 40)}…` : text)
