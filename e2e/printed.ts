/** A printed item of each kind, the shorter ones; first those with the most risks on paper. */
export const oneOfEachKind = [
  ['curriculum', 'one-day'],
  ['plan', 'friendship-and-fear'],
  ['card', 'first-drive-cards'],
  ['slides', 'how-does-your-robot-learn'],
  ['kit', 'sorting-cards'],
  ['checklist', 'the-day-before'],
  ['links', 'further-material'],
  ['observation', 'observation-card'],
  ['observer', 'observer-sheet'],
  ['sheet', 'q-map'],
  ['solution', 'solutions-first-drive'],
  ['worksheet', 'three-ways'],
] as const
