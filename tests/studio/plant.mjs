// A plant that is quickly grown, as a person wrote it.
export const TEXT = `// A plant to play with.
{
  "title": "A test",
  "seed": 3, // its chances
  "film": {"frames": 1, "size": [160, 120]},
  "scene": {"setting": "studio", "camera": {"location": [0, 0.7, 3], "look_at": [0, 0.5, 0], "angle": 40}},
  "organisms": [
    /* The only one. */
    {
      "kind": "plant", "name": "herb", "height": 1,
      "place": {"at": [[0, 0]]},
      "grammar": {
        "axiom": "A", "steps": 4, "angle": 25,
        "rules": [
          "A -> F[+A][-A]FA",
          "F -> FF"
        ]
      }
    }
  ]
}
`;
