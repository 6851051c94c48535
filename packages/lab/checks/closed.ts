import { numberOf, type Kind } from './kind.ts'

/** On the map of the first robot's program, the road `from` one station `to` another is closed. */
export const closed: Kind<object> = {
  needs: ['from', 'to'],
  lacks: ['open'],
  begin: () => ({}),
  observe: (check, moment) =>
    moment.closed.some(([from, to]) => from === numberOf(check, 'from') && to === numberOf(check, 'to')),
  missing: (check) => ({
    what: 'open',
    facts: { from: numberOf(check, 'from'), to: numberOf(check, 'to') },
  }),
}
