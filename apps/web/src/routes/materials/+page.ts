import { library } from '#features/materials/feature.ts'

export const load = () => library.fetchMaterials()
