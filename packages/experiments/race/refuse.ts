import { limits, racers, type Race } from './types.ts'

/** @throws RangeError that names what is outside the limits of a race */
export function refuseLanes({ lanes, tries, runs }: Race): void {
  whole('The number of lanes', lanes.length, limits.lanes.least, limits.lanes.most)
  whole('The number of tries', tries, 1, limits.tries)
  whole('The number of runs', runs, 1, limits.runs)
  for (const [index, lane] of lanes.entries()) {
    if (!racers.includes(lane.racer)) throw new RangeError(`Lane ${index + 1} has no racer ${lane.racer}.`)
    for (const name of ['alpha', 'gamma', 'nu', 'rho'] as const)
      if (!(lane[name] >= 0 && lane[name] <= 1))
        throw new RangeError(`${name} of lane ${index + 1} is ${lane[name]}, not from 0 to 1.`)
  }
}

function whole(what: string, value: number, least: number, most: number): void {
  if (!Number.isInteger(value) || value < least || value > most)
    throw new RangeError(`${what} is ${value}; it goes from ${least} to ${most}.`)
}
