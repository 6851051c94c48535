const bo = {
  ...{ id: 'bo', pose: { x: 50, y: 50, heading: 0 }, program: 'main', brain: '' },
  config: { wheelDiameter: 5.6, trackWidth: 11, sensors: {}, drive: { left: 'B', right: 'C' } },
}

/** A small project, different for each mark. */
export const projectText = (mark: string, assets: object = {}): string =>
  JSON.stringify({
    ...{ botgarten: 1, name: `Garden ${mark}`, card: 'friendship', brains: {}, assets },
    programs: { main: { stacks: [], config: { stacks: [] } } },
    world: {
      size: { width: 200, height: 150 },
      floor: { colour: '#ffffff' },
      ...{ areas: [], lines: [], obstacles: [], robots: [bo] },
    },
  })
