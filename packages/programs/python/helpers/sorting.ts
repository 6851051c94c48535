import type { Helpers } from '../helpers.ts'

/**
 * k-means on plain lists (Lloyd 1982); it begins ten times with readings that lie far apart (Gonzalez 1985),
 * the same every time, and takes the best.
 */
export const sorting: Helpers = {
  distance_to: ({ math }) => [
    '(reading, centre):',
    `return ${math('sqrt')}(sum((a - b) ** 2 for a, b in zip(reading, centre)))`,
  ],
  group_of: ({ call }) => [
    '(reading, centres):',
    `away = [${call('distance_to')}(reading, centre) for centre in centres]`,
    'return away.index(min(away)) + 1',
  ],
  name_of: () => ['(group, names):', 'return names.get(group, str(group))'],
  nearest: ({ call }) => [
    '(reading, centres):',
    `return min(${call('distance_to')}(reading, centre) for centre in centres)`,
  ],
  middle_of: () => ['(readings):', 'return [sum(parts) / len(readings) for parts in zip(*readings)]'],
  spread: ({ call }) => [
    '(readings, first, count):',
    'centres = [first]',
    'while len(centres) < count:',
    `    centres.append(max(readings, key=lambda one: ${call('nearest')}(one, centres)))`,
    'return centres',
  ],
  moved: ({ call }) => [
    '(centres, readings):',
    'for _ in range(20):',
    `    groups = [${call('group_of')}(one, centres) for one in readings]`,
    '    for k in range(len(centres)):',
    '        own = [one for one, group in zip(readings, groups) if group == k + 1]',
    `        centres[k] = ${call('middle_of')}(own) if own else centres[k]`,
    'return centres',
  ],
  error_of: ({ call }) => [
    '(readings, centres):',
    `return sum(${call('nearest')}(one, centres) ** 2 for one in readings)`,
  ],
  find_groups: ({ call }) => [
    '(readings, count):',
    'best = None',
    'for first in readings[:10]:',
    `    centres = ${call('moved')}(${call('spread')}(readings, first, count), readings)`,
    `    error = ${call('error_of')}(readings, centres)`,
    '    if best is None or error < best[0]:',
    '        best = (error, centres)',
    'met = []',
    'for one in readings:',
    `    centre = best[1][${call('group_of')}(one, best[1]) - 1]`,
    '    if centre not in met:',
    '        met.append(centre)',
    'return met',
  ],
}
